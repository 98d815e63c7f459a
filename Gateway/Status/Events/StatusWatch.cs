using Nowpose.Gateway.Clock;
using Nowpose.Gateway.Status.Joints;

namespace Nowpose.Gateway.Status.Events;

/// <summary>Looks several times per second for what is wrong: for the list of events and for headsets.</summary>
sealed class StatusWatch : IDisposable
{
    static readonly TimeSpan Interval = TimeSpan.FromSeconds(0.2);

    readonly Conditions _conditions;
    readonly EventList _events;
    readonly JointBoard _joints;
    readonly JointStatusTopic _topic;
    readonly PlantClocks _plant;
    readonly Lock _lock = new();
    readonly ITimer _timer;
    (string Source, int Steps)? _clock;
    bool _isDisposed;

    public StatusWatch(Conditions conditions, EventList events, JointBoard joints, JointStatusTopic topic, PlantClocks plant, TimeProvider time)
    {
        (_conditions, _events, _joints, _topic, _plant) = (conditions, events, joints, topic, plant);
        _timer = time.CreateTimer(_ => Look(), null, Interval, Interval);
    }

    public void Look()
    {
        // A look that takes longer than the interval is not overtaken.
        if (!_lock.TryEnter()) return;
        try
        {
            if (_isDisposed) return;
            _events.Update(_conditions.Read());
            _topic.Publish(_joints.Read());
            NoteSteps();
        }
        finally
        {
            _lock.Exit();
        }
    }

    public void Dispose()
    {
        _timer.Dispose();
        lock (_lock) _isDisposed = true;
        _topic.Dispose();
    }

    void NoteSteps()
    {
        if (_plant.Control is not { } control) return;
        var now = (control.Name, control.Model.Steps);
        if (_clock is { } before && before.Source == now.Name && now.Steps > before.Steps)
            _events.Note(new Condition("clock", control.Name, "was stepped", "samples from before the step are not comparable", Level.Warning));
        _clock = now;
    }
}
