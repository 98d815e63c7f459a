using Nowpose.Cli.Figures.Model;

namespace Nowpose.Cli.Figures.Swing;

/// <summary>Figs 16 to 18: the paper's proof of concept, a virtual gripper on a swinging robot.</summary>
sealed class SwingStudy(FigureSettings settings, CancellationToken cancel) : IFigureStudy
{
    readonly SwingRuns _runs = new(settings, cancel);

    public IReadOnlyList<Action> Work => _runs.Work;

    public IEnumerable<Figure> Figures()
    {
        var set = _runs.Set;
        return [Figure16.Of(set), Figure17.Of(set), Figure18.Of(set)];
    }
}
