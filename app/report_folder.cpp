#include "app/report_folder.h"

#include "app/picture_keeper.h"
#include "app/report.h"

namespace enfilade {

FolderKind reportFolder() {
  const std::set<std::string> proof = {"frames.csv", "summary.json", "report.html"};
  FolderKind kind{proof, proof};
  kind.own.insert({kContactSheetFile, kPicturesFolder});
  return kind;
}

}  // namespace enfilade
