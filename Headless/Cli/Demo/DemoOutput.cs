using Nowpose.Web;

namespace Nowpose.Cli.Demo;

/// <summary>The folder a run writes to; made, and tried, before the run: twenty seconds are too long to learn that a disk is full.</summary>
sealed class DemoOutput
{
    DemoOutput(string folder)
    {
        ResultPath = Path.Combine(folder, "result.json");
        ReportPath = Path.Combine(folder, "report.html");
    }

    public string ResultPath { get; }
    public string ReportPath { get; }

    /// <exception cref="InputException">The folder cannot be written to.</exception>
    public static DemoOutput At(string folder)
    {
        try
        {
            var output = new DemoOutput(Directory.CreateDirectory(folder).FullName);
            using var probe = File.Open(output.ResultPath, FileMode.OpenOrCreate, FileAccess.Write);
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
