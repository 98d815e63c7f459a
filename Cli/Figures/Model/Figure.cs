namespace Nowpose.Cli.Figures.Model;

/// <summary>One recomputed figure of the paper: the paper's claim, our result and the data.</summary>
/// <param name="Number">Number of the figure in the paper, for example "13a".</param>
sealed record Figure(string Number, string Title)
{
    /// <summary>The paper's claim in our words.</summary>
    public required string Claim { get; init; }

    /// <summary>The criteria that decide whether the claim holds.</summary>
    public required IReadOnlyList<Criterion> Criteria { get; init; }

    /// <summary>The data for the figure's CSV file.</summary>
    public required FigureTable Table { get; init; }

    /// <summary>Results of Nowpose's own methods under the same conditions; null if there are none.</summary>
    public string Beyond { get; init; }

    /// <summary>Conditions of this figure, in addition to those that all figures share.</summary>
    public required string Conditions { get; init; }

    public IReadOnlyList<FigurePlot> Plots { get; init; } = [];

    public IReadOnlyList<FigureDrawing> Drawings { get; init; } = [];

    /// <summary>Summary of all runs; null if the figure needs none.</summary>
    public FigureSummary Summary { get; init; }

    public Verdict Verdict => Criterion.Judge(Criteria);

    /// <summary>Name of the CSV file.</summary>
    public string FileName { get; init; } = $"figure-{Number}.csv";
}
