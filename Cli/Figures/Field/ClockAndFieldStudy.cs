using Nowpose.Cli.Figures.Clocks;
using Nowpose.Cli.Figures.Model;

namespace Nowpose.Cli.Figures.Field;

/// <summary>Figs 4 and 8: the error that a latency causes, and the accuracy of the synchronised clock.</summary>
sealed class ClockAndFieldStudy : IFigureStudy
{
    readonly ErrorField _field;
    readonly ClockRuns _clocks;

    public ClockAndFieldStudy(FigureSettings settings)
    {
        _field = new ErrorField(settings);
        _clocks = new ClockRuns(settings);
        Work = [.. _clocks.Work, .. _field.Work];
    }

    public IReadOnlyList<Action> Work { get; }

    public IEnumerable<Figure> Figures() => [Figure04.Of(_field, _clocks), Figure08.Of(_clocks)];
}
