using Nowpose.Cli.Figures.Model;

namespace Nowpose.Cli.Figures;

/// <summary>Makes the data of one or more figures.</summary>
interface IFigureStudy
{
    /// <summary>Independent of each other: they may run in any order and at the same time, once each.</summary>
    IReadOnlyList<Action> Work { get; }

    /// <summary>When all work is done.</summary>
    IEnumerable<Figure> Figures();
}
