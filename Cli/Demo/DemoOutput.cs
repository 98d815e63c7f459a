using Nowpose.Cli.Demo.Paper;
using Nowpose.Cli.Figures.Model;
using Nowpose.Web;

namespace Nowpose.Cli.Demo;

/// <summary>The folder that a run writes to.</summary>
sealed class DemoOutput
{
    DemoOutput(string folder)
    {
        ResultPath = Path.Combine(folder, "result.json");
        ReportPath = ReportIn(folder);
        SessionPath = Path.Combine(folder, "session.jsonl");
        Folder = folder;
    }

    public string Folder { get; }
    public string ResultPath { get; }
    public string ReportPath { get; }

    /// <summary>Path of the headset's recording, for <c>replay</c>, <c>sync</c> and <c>recommend</c>.</summary>
    public string SessionPath { get; }

    /// <summary>Gets the path of the report in a folder.</summary>
    public static string ReportIn(string folder) => Path.Combine(folder, "report.html");

    /// <summary>Creates the folder and removes an earlier run's files, so that they cannot be mistaken for this run's.</summary>
    /// <exception cref="InputException">The folder is not writable. This is checked before the run, not after it.</exception>
    public static DemoOutput At(string folder) => OutputPath.InFolder("--out", folder, full =>
    {
        var output = new DemoOutput(full);
        File.Delete(output.ReportPath);
        File.Delete(output.SessionPath);
        PaperOutput.RemoveEarlier(output.Folder);
        File.WriteAllText(output.ResultPath, "");
        File.Delete(output.ResultPath);
        return output;
    });

    /// <param name="figures">The paper's figures of this run; null without <c>--paper</c>.</param>
    public void Write(DemoScore score, DemoRun run, DemoResult result, IReadOnlyList<Figure> figures = null)
    {
        File.WriteAllText(ResultPath, DemoResultJson.Of(result));
        File.WriteAllText(ReportPath, ReportPage.Render(DemoReport.Of(score, run, result, figures)));
    }
}
