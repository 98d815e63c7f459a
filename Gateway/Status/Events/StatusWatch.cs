using Nowpose.Gateway.Clock;
using Nowpose.Gateway.Status.Joints;

namespace Nowpose.Gateway.Status.Events;

/// <summary>Checks for faults five times per second, and updates the list of events and the lists of joints and signals for headsets.</summary>
sealed class StatusWatch : IDisposable
{
    static readonly TimeSpan Interval = TimeSpan.FromSeconds(0.2);

    readonly Conditions _conditions;
    readonly EventList _events;
    readonly JointBoard _joints;
    readonly JointStatusTopic _topic;
    readonly Action _reportSignals;
    readonly ClockSteps _steps;
    readonly PeriodicTask _look;

    /// <param name="reportSignals">Updates the list of signals.</param>
    public StatusWatch(
        Conditions conditions, EventList events, JointBoard joints, JointStatusTopic topic, Action reportSignals, PlantClocks plant, TimeProvider time, Action<string> log)
    {
        (_conditions, _events, _joints, _topic, _reportSignals, _steps) = (conditions, events, joints, topic, reportSignals, new ClockSteps(plant, events));
        _look = new PeriodicTask(LookNow, Interval, EventTexts.NotUpdated, log, time);
        _look.Start();
    }

    /// <summary>Checks once, unless the previous check is still running.</summary>
    public void Look() => _look.RunUnlessBusy();

    public void Dispose()
    {
        _look.Dispose();
        _look.Exclude(_topic.Dispose);
    }

    void LookNow()
    {
        var joints = _joints.Read();
        _events.Update(_conditions.Read(joints));
        _topic.Publish(joints);
        _reportSignals();
        _steps.Look();
    }
}
