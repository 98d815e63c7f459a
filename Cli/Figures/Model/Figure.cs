namespace Nowpose.Cli.Figures.Model;

/// <summary>One figure of the paper, computed anew: what the paper says of it, what we find, and the data.</summary>
/// <param name="Number">As the paper counts: "13a".</param>
sealed record Figure(string Number, string Title)
{
    /// <summary>What the paper says, in our words.</summary>
    public required string Claim { get; init; }

    /// <summary>What decides whether the claim holds.</summary>
    public required IReadOnlyList<Criterion> Criteria { get; init; }

    /// <summary>What is written to the figure's CSV.</summary>
    public required FigureTable Table { get; init; }

    /// <summary>What our own methods do under the same conditions; null where there is nothing to say.</summary>
    public string Beyond { get; init; }

    /// <summary>How the data were made, beyond what holds for all figures.</summary>
    public required string Conditions { get; init; }

    public IReadOnlyList<FigurePlot> Plots { get; init; } = [];

    public IReadOnlyList<FigureDrawing> Drawings { get; init; } = [];

    /// <summary>Numbers over all runs; null where the table says it all.</summary>
    public FigureSummary Summary { get; init; }

    public Verdict Verdict => Criterion.Judge(Criteria);

    public string FileName => $"figure-{Number}.csv";
}
