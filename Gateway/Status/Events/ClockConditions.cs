using Nowpose.Gateway.Clock;

namespace Nowpose.Gateway.Status.Events;

/// <summary>Finds the faults of the control clock, of the plant's other clocks, and of stamps.</summary>
static class ClockConditions
{
    public static IEnumerable<Condition> Of(ServedClock clock) =>
        OfRates(clock).Concat(OfState(clock)).Concat(OfNames(clock)).Concat(OfStamps(clock));

    static string NameOf(ServedClock clock) => clock.Source == PlantClocks.Own ? EventTexts.OwnClock : EventTexts.ControlClock(clock.Source);

    // Only the control clock affects the gateway's readiness. Samples with stamps of another clock are refused while its rate is wrong.
    static IEnumerable<Condition> OfRates(ServedClock clock) =>
        from one in clock.Status()
        where one.WrongRate != null
        select new Condition("clock", one.Name, EventTexts.RunsAtWrongRate, "", Level.Error, one.IsControlClock)
        {
            Headline = EventTexts.ClockAtWrongRate(one.Name, one.WrongRate.Value),
            Remedy = EventRemedies.ClockRate,
        };

    static IEnumerable<Condition> OfState(ServedClock clock)
    {
        // A wrong rate has a condition of its own.
        if (!clock.IsSynchronised && clock.WrongRate == null)
            yield return new(
                "clock", clock.Source, EventTexts.NotServed,
                clock.IsNotOffered ? EventTexts.ClockNotOffered([.. clock.Status().Where(one => !one.IsControlClock).Select(one => one.Name)])
                    : EventTexts.ClockState(clock.State.Word()), Level.Error, true)
            {
                Headline = EventTexts.ClockNotServed(NameOf(clock)),
                Remedy = clock.Source == PlantClocks.Own ? "" : clock.IsNotOffered ? EventRemedies.ClockName : EventRemedies.ClockAdapter,
                // Not normal in holdover, which means that the clock was synchronised before.
                IsNormalAtStart = clock.State is ClockState.Unsynchronised or ClockState.Converging,
            };
        var stamps = clock.Stamps;
        if (stamps.Found is not { } found) yield break;
        yield return found.IsContradiction
            ? new("clock", clock.Source, EventTexts.StampsContradict, found.Reason, Level.Error, true)
            {
                Headline = EventTexts.StampsContradictClock(NameOf(clock)),
                Remedy = found.Remedy,
            }
            : new("clock", clock.Source, EventTexts.NotSystemClock, found.Reason, Level.Warning)
            {
                Headline = EventTexts.ClockNotSystemClock(NameOf(clock)),
                Remedy = found.Remedy,
            };
    }

    // Does not affect the gateway's readiness, because the stamps of each client are converted with its own times.
    static IEnumerable<Condition> OfNames(ServedClock clock) => clock.Contradictions.Select(
        one => new Condition(
            "clock", one.Clock, EventTexts.HasTwoTimes, EventTexts.TimesDiffer(one.Other, one.Client, one.Ahead.TotalMilliseconds), Level.Error)
        {
            Headline = EventTexts.ClockWithTwoTimes(one.Clock),
            Remedy = EventRemedies.ClockNames,
        });

    static IEnumerable<Condition> OfStamps(ServedClock clock) =>
    [
        .. clock.Stamps.Ahead.Select(one => OfSource(one.Source, EventTexts.Future, EventTexts.FutureBy(one.By), StampMessages.SourceRemedy)),
        .. clock.Stamps.Behind.Select(one => OfSource(one.Source, EventTexts.TooOld, EventTexts.TooOldBy(one.By), StampMessages.LateSourceRemedy)),
    ];

    static Condition OfSource(string source, string what, string by, string remedy) => new("source", source, what, by, Level.Warning)
    {
        Headline = EventTexts.SourceDoes(source, what),
        Remedy = remedy,
    };
}
