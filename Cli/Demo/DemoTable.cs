using Spectre.Console;

namespace Nowpose.Cli.Demo;

/// <summary>Prints the result as text: the errors without and with compensation, then the conditions.</summary>
static class DemoTable
{
    public static void Print(DemoRun run, DemoScore score, DemoResult result, DemoOutput output)
    {
        var settings = run.Settings;
        var console = ResultConsole.Create();
        console.WriteLine(DemoTexts.Title(settings.Robot.Name, settings.Predictor, result.Network, settings.IsVirtual));
        foreach (var note in result.Notes ?? []) console.WriteLine(DemoTexts.Note(note));
        console.Write(Errors(score, result));
        console.Write(Facts([DemoFacts.DisplayLatency(settings), .. DemoFacts.Time(settings), .. DemoFacts.Results(run, score, result)]));
        if (result.Repeats != null) console.Write(Repeats(result.Repeats));
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

    static Table Repeats(DemoRepeats repeats)
    {
        var table = new Table().Title(DemoTexts.Seeds(repeats.Seeds[0], repeats.Seeds[^1])).AddColumn("");
        foreach (var heading in DemoTexts.RepeatColumns) table.AddColumn(new TableColumn(heading).RightAligned());
        foreach (var (name, figure) in repeats.Figures) table.AddRow(name, Number(figure.Mean), Number(figure.Min), Number(figure.Max));
        return table;
    }

    static Grid Facts(IEnumerable<(string Label, string Value)> facts)
    {
        var grid = new Grid().AddColumn().AddColumn();
        foreach (var (label, value) in facts) grid.AddRow(Markup.Escape(label), Markup.Escape(value));
        return grid;
    }

    static string Number(double value) => RunTexts.Number(value, "0.####");
    static string Mm(double? value) => RunTexts.Number(value, "0.00", " mm");
    static string Percent(double? share) => RunTexts.Number(100 * share, "0.0", " %");
}
