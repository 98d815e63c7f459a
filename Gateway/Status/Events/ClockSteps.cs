using Nowpose.Gateway.Clock;
using Nowpose.Gateway.Messages;

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
            events.Note(new Condition("clock", now.Source, "was stepped", EventTexts.NotComparable, Level.Warning)
            {
                Headline = EventTexts.ClockStepped(now.Source),
            });
        _last = now;
    }
}
