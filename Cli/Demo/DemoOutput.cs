using Nowpose.Web;

namespace Nowpose.Cli.Demo;

/// <summary>The folder a run writes to.</summary>
sealed class DemoOutput
{
    DemoOutput(string folder)
    {
        ResultPath = Path.Combine(folder, "result.json");
        ReportPath = Path.Combine(folder, "report.html");
        SessionPath = Path.Combine(folder, "session.jsonl");
    }

    public string ResultPath { get; }
    public string ReportPath { get; }

    /// <summary>What the headset records while it runs, for <c>replay</c>, <c>sync</c> and <c>recommend</c>.</summary>
    public string SessionPath { get; }

    /// <summary>Makes the folder, and takes an earlier run's files away so that nobody takes them for this one's.</summary>
    /// <exception cref="InputException">It cannot be written to; better known before the run than twenty seconds later.</exception>
    public static DemoOutput At(string folder)
    {
        try
        {
            var output = new DemoOutput(Directory.CreateDirectory(folder).FullName);
            File.Delete(output.ReportPath);
            File.Delete(output.SessionPath);
            File.WriteAllText(output.ResultPath, "");
            File.Delete(output.ResultPath);
            return output;
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException or ArgumentException or NotSupportedException)
        {
            throw new InputException($"--out: {folder}: cannot be written to: {e.Message.ReplaceLineEndings(" ")}", e);
        }
    }

    public void Write(DemoScore score, DemoRun run, DemoResult result)
    {
        File.WriteAllText(ResultPath, DemoResultJson.Of(result));
        File.WriteAllText(ReportPath, ReportPage.Render(DemoReport.Of(score, run, result)));
    }
}
