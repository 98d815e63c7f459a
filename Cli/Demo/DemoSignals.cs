using Nowpose.Session;
using Nowpose.Simulation.Work;

namespace Nowpose.Cli.Demo;

/// <summary>Stores the displayed values of the cell's signals for every frame. Filled during the run, read after it.</summary>
sealed class DemoSignals(CellWork work)
{
    readonly IReadOnlyList<string> _names = work.Signals;
    readonly List<double?> _shown = [];
    CompensationSession _followed;

    public CellWork Work => work;

    /// <summary>Gets the displayed value of a signal in a frame; null before its first value.</summary>
    public double? At(int frame, int signal) => _shown[frame * _names.Count + signal];

    /// <summary>Requests all signals in a session and records them from now on.</summary>
    public void Follow(CompensationSession session)
    {
        if (session == null || session == _followed) return;
        _followed = session;
        foreach (var name in _names) session.Signals.Need(name);
    }

    /// <summary>Records the values of all signals in the newest frame.</summary>
    public void Add()
    {
        foreach (var name in _names)
            _shown.Add(_followed?.Signals.Table.Find(name) is { IsKnown: true } signal ? signal.Value : null);
    }
}
