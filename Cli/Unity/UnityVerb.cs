using System.CommandLine;
using Nowpose.Editor.Setup;
using Nowpose.Gateway.Options;

namespace Nowpose.Cli.Unity;

/// <summary><c>unity PROJECT</c>: prepares a Unity project for the package.</summary>
static class UnityVerb
{
    public static Command Create()
    {
        var project = new Argument<string>("PROJECT") { Description = "Folder of the Unity project" };
        var mrtk3 = SwitchOption.Create("--mrtk3", "Add MRTK3 and the packages that a HoloLens 2 needs");
        var webSocket = SwitchOption.Create("--native-websocket", "Add NativeWebSocket, another WebSocket client");
        var samples = TextOption.CreateList("--sample", "Copy a sample of the package into Assets/Samples: " + SampleNames() + ".", "NAME");
        var package = TextOption.Create(
            "--package", "Source of the package: a Git URL, file:PATH, a folder or a .tgz file. Default: the source in the project's manifest or, if it "
                + "has none, the folder of this clone or published program.",
            "ADDRESS");
        var onConflict = ChoiceOption.Create(
            "--on-conflict", "Treatment of older or different entries; refuse changes nothing", "refuse", ["refuse", "keep", "replace"]);
        var check = SwitchOption.Create("--check", "List the changes without making them. The exit status is 1 if there are any.");
        var json = SwitchOption.Create("--json", "Print JSON instead of text");
        var verb = new Command("unity", "Prepare a Unity project: registries, dependencies, testables and the package in its Packages/manifest.json.")
        {
            project, mrtk3, webSocket, samples, package, onConflict, check, json,
        };
        verb.SetAction((parsed, cancel) =>
        {
            var settings = new PreparationSettings(
                parsed.GetValue(mrtk3), parsed.GetValue(webSocket), parsed.GetValue(samples) ?? [], parsed.GetValue(package),
                Enum.Parse<ConflictRule>(parsed.GetValue(onConflict), ignoreCase: true));
            return RunAsync(parsed.GetValue(project), settings, parsed.GetValue(check), parsed.GetValue(json), cancel);
        });
        return verb;
    }

    static async Task<int> RunAsync(string project, PreparationSettings settings, bool isCheck, bool isJson, CancellationToken cancel)
    {
        var preparation = await Invocation.ReadAsync(
            () => FileFault.Report(() => Preparation.Plan(UnityProject.Open(project), settings), e => e.Message), cancel);
        var backup = isCheck ? null : FileFault.Report(() => preparation.Apply(), e => e.Message);
        if (isCheck && preparation.Obstacle is { } obstacle) Console.Error.WriteLine(ConsoleMessages.WouldFail(obstacle));
        foreach (var note in preparation.Notes) Console.Error.WriteLine(ConsoleMessages.Line(note));
        Console.Out.Write(isJson ? PreparationOutput.Json(preparation, isCheck, backup) : PreparationOutput.Text(preparation, isCheck, backup));
        return isCheck && preparation.Changes.Count > 0 ? ExitStatus.Failed : ExitStatus.Done;
    }

    // The help must also work if the package's files are missing or damaged.
    static string SampleNames()
    {
        const string unknown = "see its package.json";
        try
        {
            var folder = PackageFolder.Find();
            return folder == null ? unknown : string.Join(", ", folder.Samples.Select(sample => sample.Name));
        }
        catch (Exception e) when (e is InputException or IOException or UnauthorizedAccessException)
        {
            return unknown;
        }
    }
}
