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
    readonly ClockSteps _steps;
    readonly Action<string> _log;
    readonly Lock _lock = new();
    readonly ITimer _timer;
    bool _isDisposed;

    public StatusWatch(
        Conditions conditions, EventList events, JointBoard joints, JointStatusTopic topic, PlantClocks plant, TimeProvider time, Action<string> log)
    {
        (_conditions, _events, _joints, _topic, _steps, _log) = (conditions, events, joints, topic, new ClockSteps(plant, events), log);
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
            _steps.Look();
        }
        catch (Exception e)
        {
            // All of them: an exception that leaves a timer's thread ends the process.
            _log($"status: the state could not be updated ({e.GetType().Name}: {e.Message})");
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
}
