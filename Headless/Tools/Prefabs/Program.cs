using Nowpose.Metas;
using Nowpose.Prefabs;
using Nowpose.Prefabs.Pictures;

const string Help = """
    Writes the prefabs, robot descriptions, settings and scenes of the Unity project that contains the current folder.

      (no option)  write assets that differ, and their .meta files if missing
      --pictures   write only the manual's pictures of prefabs and sample that differ: Documentation~/images/pose-appearance.svg,
                   status-panel.svg and cell.svg
      --check      write nothing, only list assets and pictures that differ

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

if (args.Contains("--check"))
{
    var assets = AssetPlan.Differing(root).Select(path => $"{path}: differs from what is built; run this tool without --check");
    var pictures = ManualPictures.Differing(root).Select(picture => $"{picture.Path}: differs from what is drawn; run this tool with --pictures");
    var differing = assets.Concat(pictures).ToList();
    foreach (var line in differing) Console.WriteLine(line);
    return differing.Count > 0 ? 1 : 0;
}
if (args.Contains("--pictures"))
{
    foreach (var (path, svg) in ManualPictures.Differing(root))
    {
        File.WriteAllText(Path.Combine(root, path), svg);
        Console.WriteLine($"wrote {path}");
    }
    return 0;
}
foreach (var path in AssetPlan.Write(root)) Console.WriteLine($"wrote {path}");
return 0;

static int Refuse(string message)
{
    Console.Error.WriteLine(message);
    return 2;
}
