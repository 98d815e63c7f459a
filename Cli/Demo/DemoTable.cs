using Nowpose.Cli.Messages;
using Spectre.Console;

namespace Nowpose.Cli.Demo;

/// <summary>Prints the result as text: the errors without and with compensation, then the conditions.</summary>
static class DemoTable
{
    public static void Print(DemoRun run, DemoScore score, DemoResult result, DemoOutput output)
    {
        var settings = run.Settings;
        var console = ResultConsole.Create();
        console.WriteLine(DemoTexts.Title(settings.Robot.Name, settings.Predictor, result.Network));
        foreach (var note in result.Notes ?? []) console.WriteLine(DemoTexts.Note(note));
        console.Write(Errors(score, result));
        console.Write(Facts(result, new DemoRangeRows(settings, result, score.Range), new DemoDelayRows(run.Frames)));
        foreach (var (label, path) in output.Written) console.WriteLine(label.PadRight(8) + path);
    }

    static Table Errors(DemoScore score, DemoResult result)
    {
        var tool = result.ToolErrorMm;
        var table = new Table();
        table.AddColumn("");
        foreach (var heading in DemoTexts.ErrorColumns)
            table.AddColumn(new TableColumn(heading).RightAligned());
        table.AddRow(DemoTexts.Rms, Mm(tool.HoldRms), Mm(tool.Rms), Percent(tool.Reduction));
        table.AddRow(DemoTexts.P95, Mm(score.HoldP95Mm), Mm(tool.P95), "");
        table.AddRow(DemoTexts.MaximumRow, Mm(tool.HoldMax), Mm(tool.Max), "");
        return table;
    }

    static Grid Facts(DemoResult result, DemoRangeRows range, DemoDelayRows delays)
    {
        var grid = new Grid().AddColumn().AddColumn();
        void Row(string label, string value) => grid.AddRow(Markup.Escape(label), Markup.Escape(value));
        var hindcast = result.Hindcast;
        var errors = hindcast.Withheld != null ? "" : ", " + DemoTexts.RmsFromTo(Mm(hindcast.HoldRmsMm), Mm(hindcast.RmsMm));
        Row(DemoTexts.AsMeasured, hindcast.ReductionText + errors);
        Row(RunTexts.ApplicationLatency, RunTexts.MedianP95(Ms(result.LatencyMs.AppP50), Ms(result.LatencyMs.AppP95)));
        Row(DemoTexts.VisualisationLatencyRow, Ms(result.LatencyMs.Visu));
        Row(DemoTexts.DisplayTimeErrorRow, DemoTexts.OnlyP95(Ms(result.LatencyMs.TotalErrorP95)));
        foreach (var (label, value) in new DemoBodyRows(result.Bodies).Rows) Row(label, value);
        foreach (var (label, value) in range.Rows) Row(label, value);
        var clock = result.Clock;
        Row(DemoTexts.ClockErrorRow, DemoTexts.MedianP95Maximum(Us(clock.OffsetErrorUsP50), Us(clock.OffsetErrorUsP95), Us(clock.OffsetErrorUsMax)));
        Row(DemoTexts.EstimatedClockErrorRow, DemoTexts.EstimatedClockErrorMedian(Us(clock.StatedErrorUsP50), Percent(clock.WithinStatedShare)));
        Row(DemoTexts.SynchronisedAfterRow, RunTexts.Number(result.Clock.ConvergedS, "0.0", " s"));
        var allocated = RunTexts.Number(result.Frame.AllocatedBytesPerFrame, "0.##", " B");
        Row(DemoTexts.FrameRow, DemoTexts.FrameTimes(Us(result.Frame.CpuUsP50), Us(result.Frame.CpuUsP99), allocated));
        Row(RunTexts.CountsRow, RunTexts.Counts(result.Frames, result.Samples, result.Dropped));
        foreach (var (label, value) in delays.Rows) Row(label, value);
        return grid;
    }

    static string Mm(double? value) => RunTexts.Number(value, "0.00", " mm");
    static string Ms(double? value) => RunTexts.Number(value, "0.0#", " ms");
    static string Us(double? value) => RunTexts.Number(value, "0.#", " µs");
    static string Percent(double? share) => RunTexts.Number(100 * share, "0.0", " %");
}
