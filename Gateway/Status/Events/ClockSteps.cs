using Nowpose.Gateway.Clock;

namespace Nowpose.Gateway.Status.Events;

/// <summary>Adds an event for each step of the control clock. Not thread-safe.</summary>
sealed class ClockSteps(PlantClocks plant, EventList events)
{
    (string Source, int Steps)? _last;

    public void Look()
    {
        if (plant.Control is not { } control) return;
        var now = (Source: control.Name, control.Model.Steps);
        if (_last is { } last && last.Source == now.Source && now.Steps > last.Steps)
            events.Note(new Condition("clock", now.Source, "was stepped", "time stamps from before the step are on another time line", Level.Warning)
            {
                Headline = $"the control clock {now.Source} was stepped",
            });
        _last = now;
    }
}
