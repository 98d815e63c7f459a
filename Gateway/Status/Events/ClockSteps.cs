using Nowpose.Gateway.Clock;

namespace Nowpose.Gateway.Status.Events;

/// <summary>
/// Adds an event for each step of the control clock, and for the first of several steps that follow each other, as of a clock with a wrong rate. Not
/// thread-safe.
/// </summary>
sealed class ClockSteps(PlantClocks plant, EventList events)
{
    // Time without a step after which the next step has its own event.
    static readonly TimeSpan MinPause = TimeSpan.FromSeconds(10);

    (string Source, int Steps)? _last;
    HeadsetTime? _stepped;

    public void Look()
    {
        if (plant.Control is not { } control) return;
        var now = (Source: control.Name, control.Model.Steps);
        if (_last is { } last && last.Source == now.Source && now.Steps > last.Steps)
        {
            var before = _stepped;
            _stepped = plant.Counter.Now;
            if (before == null || _stepped - before > MinPause) Note(now.Source);
        }

        _last = now;
    }

    void Note(string source) => events.Note(
        new Condition("clock", source, "was stepped", EventTexts.NotComparable, Level.Warning) { Headline = EventTexts.ClockStepped(source) });
}
