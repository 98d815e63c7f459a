using Spectre.Console;

namespace Nowpose.Cli.Demo.Paper;

/// <summary>Prints the paper's claims as text, with the paper's value and the measured one.</summary>
static class PaperTable
{
    public static void Print(IReadOnlyList<PaperClaim> claims)
    {
        var table = new Table().AddColumns("figure", FigurePageTexts.ClaimColumn, "paper", "measured", "verdict");
        foreach (var claim in claims)
            table.AddRow(
                claim.Figure, Markup.Escape(claim.Claim), Markup.Escape(claim.PaperText), Markup.Escape(claim.MeasuredText),
                claim.Verdict);
        ResultConsole.Create().Write(table);
    }
}
