using Nowpose.Cli.Figures.Model;

namespace Nowpose.Cli.Figures;

/// <summary>Computes the data of one or more figures.</summary>
interface IFigureStudy
{
    /// <summary>Independent work items. They may run in any order and concurrently, each once.</summary>
    IReadOnlyList<Action> Work { get; }

    /// <summary>Gets the figures. Call this when all work is finished.</summary>
    IEnumerable<Figure> Figures();
}
