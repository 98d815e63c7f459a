using Nowpose.Cli.Figures.Model;

namespace Nowpose.Cli.Figures;

/// <summary>Computes the data of one or more figures.</summary>
interface IFigureStudy
{
    /// <summary>Independent work items. Each must run once. They can run in any order and in parallel.</summary>
    IReadOnlyList<Action> Work { get; }

    /// <summary>Gets the figures. Call this method after all work items have finished.</summary>
    IEnumerable<Figure> Figures();
}
