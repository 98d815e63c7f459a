using System.Text.Json;
using Nowpose.Cli.Calibrate;
using Nowpose.Cli.Demo.Paper;
using Nowpose.Cli.Figures.Model;
using Nowpose.Gateway;
using Nowpose.Gateway.Messages;
using Nowpose.Gateway.Options;
using Nowpose.Web;

namespace Nowpose.Cli.Demo;

/// <summary>The output folder of a run. Until it is disposed, other runs cannot use the folder.</summary>
sealed class DemoOutput : IDisposable
{
    readonly bool _isPaper;
    readonly FileStream _lock;

    DemoOutput(string folder, bool isPaper)
    {
        _isPaper = isPaper;
        _lock = Lock(folder);
        ResultPath = Path.Combine(folder, "result.json");
        ReportPath = ReportIn(folder);
        SessionPath = Path.Combine(folder, "session.jsonl");
        Folder = folder;
    }

    public string Folder { get; }
    public string ResultPath { get; }
    public string ReportPath { get; }

    /// <summary>Path of the headset's recording, which <c>replay</c>, <c>sync</c> and <c>recommend</c> read.</summary>
    public string SessionPath { get; }

    /// <summary>The files of the run that exist. A run that was interrupted before the robot was described has no session.</summary>
    public IEnumerable<(string Label, string Path)> Written =>
        new[] { ("result", ResultPath), ("report", ReportPath), ("session", SessionPath) }.Where(file => File.Exists(file.Item2));

    /// <summary>Gets the path of the report in a folder.</summary>
    public static string ReportIn(string folder) => Path.Combine(folder, "report.html");

    /// <summary>Creates the folder and checks that it is writable. The files of an earlier run stay until <see cref="RemoveEarlier"/>.</summary>
    /// <param name="isPaper">Whether the run also writes the files of <c>--paper</c>. Without it, these files are kept.</param>
    /// <param name="inputs">Paths of the input files, which are never removed; null for an input that was not given.</param>
    /// <exception cref="InputException">
    /// The folder or the calibration in it is not writable, another run uses the folder, or an input or a recording of another program is among the
    /// files to write.
    /// </exception>
    public static DemoOutput At(string folder, bool isPaper, params string[] inputs) => OptionPath.InFolder("--out", folder, full =>
    {
        var output = new DemoOutput(full, isPaper);
        try
        {
            OptionPath.RequireNoInput("--out", [output.ReportPath, output.SessionPath, output.ResultPath], inputs);
            output.RequireNoRecording();
            if (isPaper) CalibrationOutput.At(output.Folder);
            return output;
        }
        catch
        {
            output.Dispose();
            throw;
        }
    });

    /// <summary>
    /// Removes the files of an earlier run, which could be mistaken for new ones. Called right before the first file is written, so that a run that
    /// ends before it keeps them.
    /// </summary>
    /// <exception cref="InputException">A file cannot be removed.</exception>
    public void RemoveEarlier() => OptionPath.Write("--out", Folder, () =>
    {
        foreach (var path in new[] { ReportPath, SessionPath, ResultPath }) File.Delete(path);
        if (_isPaper) PaperOutput.RemoveEarlier(Folder);
    });

    public void Dispose() => _lock.Dispose();

    // Two runs would mix their files.
    static FileStream Lock(string folder)
    {
        var path = Path.Combine(folder, ".nowpose.lock");
        return FileFault.Report(
            () => new FileStream(path, FileMode.OpenOrCreate, FileAccess.Write, FileShare.None, 1, FileOptions.DeleteOnClose),
            e => FileFault.IsInUse(e) ? DemoMessages.FolderInUse(folder) : PathMessages.NotWritten($"--out: {path}", e));
    }

    // A result or a report can be computed again, but a recording of another program cannot.
    void RequireNoRecording()
    {
        if (new FileInfo(SessionPath) is { Exists: true, Length: > 0 } && IsRecordingOfAnother(File.ReadLines(SessionPath).First()))
            throw new InputException(DemoMessages.OtherRecording(SessionPath));
    }

    static bool IsRecordingOfAnother(string header)
    {
        try
        {
            using var json = JsonDocument.Parse(header);
            var root = json.RootElement;
            return root.ValueKind == JsonValueKind.Object && root.TryGetProperty("kind", out _)
                && !(root.TryGetProperty("headset", out var name) && name.ValueKind == JsonValueKind.String && name.ValueEquals(DemoStage.HeadsetName));
        }
        catch (JsonException)
        {
            return false;
        }
    }

    /// <param name="figures">The paper's figures from this run; null without <c>--paper</c>.</param>
    public void Write(DemoScore score, DemoRun run, DemoResult result, IReadOnlyList<Figure> figures = null)
    {
        OutputFile.Write(ResultPath, JsonText.Of(result, isRounded: run.Settings.IsVirtual));
        OutputFile.Write(ReportPath, Pages.Report.Render(DemoReport.Of(score, run, result, figures)));
    }
}
