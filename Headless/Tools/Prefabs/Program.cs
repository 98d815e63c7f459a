using Nowpose.Metas;
using Nowpose.Prefabs;
using Nowpose.Prefabs.Pictures;

const string Help = """
    Writes the prefabs, robot descriptions, settings and scenes of the Unity project that contains the current folder.

      (no option)  write assets that differ, and their .meta files if missing
      --check      write nothing, only list assets that differ
      --pictures   draw the manual's pictures of prefabs and sample: Documentation~/images/pose-appearance.svg, status-panel.svg and cell.svg

    Exit status: 0 no differences, 1 differences, 2 invalid arguments.
    """;

if (args.Contains("--help"))
{
    Console.WriteLine(Help);
    return 0;
}
var unknown = args.FirstOrDefault(a => a is not ("--check" or "--pictures"));
if (unknown != null) return Refuse($"unknown option {unknown}; use --check, --pictures or --help");
var root = ProjectRoot.Find(Directory.GetCurrentDirectory());
if (root == null) return Refuse($"no Unity project at or above {Directory.GetCurrentDirectory()}");

if (args.Contains("--pictures"))
{
    foreach (var path in ManualPictures.Write(root)) Console.WriteLine($"wrote {path}");
    return 0;
}
var isCheck = args.Contains("--check");
var differing = isCheck ? AssetPlan.Differing(root) : AssetPlan.Write(root);
foreach (var path in differing) Console.WriteLine(isCheck ? $"{path}: differs from what is built; run this tool without --check" : $"wrote {path}");
return isCheck && differing.Count > 0 ? 1 : 0;

static int Refuse(string message)
{
    Console.Error.WriteLine(message);
    return 2;
}
