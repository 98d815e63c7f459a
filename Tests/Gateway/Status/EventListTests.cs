using System.Globalization;
using NUnit.Framework;
using Nowpose.Gateway.Status.Events;

namespace Nowpose.Headless.Tests.Gateway.Status;

public class EventListTests
{
    readonly SteppedTime _time = new();
    readonly List<string> _log = [];
    EventList _events;

    [SetUp]
    public void Open()
    {
        _log.Clear();
        _events = new EventList(_time, (line, _) => _log.Add(line));
    }

    static Condition Joint(string name, string reason = "status Bad", DateTimeOffset? since = null) =>
        new("joint", name, "is refused", reason, Level.Error, true, since);

    [Test]
    public void Update_ConditionBeginsAndEnds_AddsOneEventAndTwoLogLines()
    {
        var began = _time.GetUtcNow();
        for (var i = 0; i < 10; i++)
        {
            _events.Update([Joint("a")]);
            _time.Advance(TimeSpan.FromSeconds(1));
        }

        Assert.That(_events.Read().Single().Until, Is.Null);
        _events.Update([]);
        _events.Update([]);

        var one = _events.Read().Single();
        Assert.That((one.Since, one.Until), Is.EqualTo((began, (DateTimeOffset?)(began + TimeSpan.FromSeconds(10)))));
        Assert.That(_log, Has.Count.EqualTo(2));
        Assert.That(_log[0], Does.Contain("joint a is refused: status Bad"));
        Assert.That(_log[1], Does.Contain("ended after 10.0 s").And.Contain("joint a"));
    }

    [TestCase(3600)]
    [TestCase(-3600)]
    public void Update_SystemClockIsSet_LogsTheDuration(int seconds)
    {
        _time.Advance(TimeSpan.FromSeconds(10));
        _events.Update([Joint("a", since: _time.GetUtcNow() - TimeSpan.FromSeconds(2))]);
        _time.Advance(TimeSpan.FromSeconds(3));

        _time.Correct(TimeSpan.FromSeconds(seconds));
        _events.Update([]);

        Assert.That(_log[1], Does.Contain("ended after 5.0 s"));
    }

    [Test]
    public void Update_SystemClockIsSetBeforeTheEventBegins_LogsTheDuration()
    {
        var missing = Joint("a") with { IsNormalAtStart = true };
        _events.Update([missing]);
        _time.Advance(EventList.StartGrace);
        _time.Correct(TimeSpan.FromHours(1));

        _events.Update([missing]);
        _time.Advance(TimeSpan.FromSeconds(2));
        _events.Update([]);

        Assert.That(_log[1], Does.Contain("ended after 5.0 s"));
    }

    [Test]
    public void Update_LineEndsInNameAndReason_WritesOneLogLinePerChange()
    {
        var condition = Joint("a\nevent 9: b\u202e", "c\r\nd\u001b[2K\u2066");
        _events.Update([condition]);
        _events.Update([]);

        Assert.That(_log.Append(condition.TextWithSince).SelectMany(line => line), Has.None.Matches<char>(c => char.IsControl(c) || c is '\u202e' or '\u2066'));
    }

    [Test]
    public void Update_ConditionRecurs_AddsANewEvent()
    {
        _events.Update([Joint("a")]);
        _events.Update([]);
        _events.Update([Joint("a")]);

        Assert.That(_events.Read().Select(one => (one.Id, one.Until == null)), Is.EqualTo(new[] { (2L, true), (1L, false) }));
    }

    [Test]
    public void Note_ManyEventsOfOneKind_KeepsTheEventsOfOtherKinds()
    {
        _events.Update([Joint("a")]);
        _events.Update([]);
        for (var i = 0; i < 2 * EventList.MaxEvents; i++) _events.Note(new Condition("headset", $"headset-{i}", "is lost", "", Level.Warning));

        var kept = _events.Read();
        Assert.That(kept, Has.Count.EqualTo(EventList.MaxEvents));
        Assert.That(kept.Count(one => one.Condition.Kind == "joint"), Is.EqualTo(1));
        Assert.That(kept[0].Condition.Which, Is.EqualTo($"headset-{(2 * EventList.MaxEvents) - 1}"), "the oldest events are removed");
    }

    [Test]
    public void Update_ReasonChanges_KeepsTheEventWithTheNewReason()
    {
        _events.Update([Joint("a", "status Bad")]);
        _events.Update([Joint("a", "NaN")]);

        Assert.That(_events.Read().Single().Condition.Reason, Is.EqualTo("NaN"));
        Assert.That(_log, Has.Count.EqualTo(1));
    }

    [Test]
    public void Update_ConditionWithStartTime_AddsAnEventThatBeginsAtThatTime()
    {
        var since = _time.GetUtcNow() - TimeSpan.FromSeconds(1.8);

        _events.Update([Joint("a", since: since)]);

        Assert.That(_events.Read().Single().Since, Is.EqualTo(since));
    }

    [Test]
    public void Date_ConditionWithOrWithoutAnEvent_HasTheTimeOfTheEventOrTheCurrentTime()
    {
        var began = _time.GetUtcNow();
        _events.Update([Joint("a")]);
        _time.Advance(TimeSpan.FromSeconds(5));

        var dated = _events.Date([Joint("a"), Joint("b")]);

        Assert.That(dated.Select(one => one.Since), Is.EqualTo(new DateTimeOffset?[] { began, began + TimeSpan.FromSeconds(5) }));
    }

    [Test]
    public void Update_NormalAtStartAndEndsWithinTheGracePeriod_AddsNoEvent()
    {
        _events.Update([Joint("a") with { IsNormalAtStart = true }, Joint("b")]);
        _time.Advance(EventList.StartGrace - TimeSpan.FromSeconds(0.1));
        _events.Update([Joint("a") with { IsNormalAtStart = true }, Joint("b")]);
        _events.Update([Joint("b")]);
        _time.Advance(TimeSpan.FromSeconds(10));
        _events.Update([Joint("b")]);

        Assert.That(_events.Read().Select(one => one.Condition.Which), Is.EqualTo(new[] { "b" }));
        Assert.That(_log, Has.Count.EqualTo(1));
    }

    [Test]
    public void Update_NormalAtStartButLongerThanTheGracePeriod_AddsAnEventFromItsStart()
    {
        _time.Advance(TimeSpan.FromSeconds(1));
        var began = _time.GetUtcNow();
        var condition = Joint("a") with { IsNormalAtStart = true };
        _events.Update([condition]);
        _time.Advance(TimeSpan.FromSeconds(1));
        Assert.That(_events.Read(), Is.Empty);
        Assert.That(_events.Date([condition]).Single().Since, Is.EqualTo(began), "an active condition without an event has a start time, too");

        _time.Advance(TimeSpan.FromSeconds(1));
        _events.Update([condition]);
        _events.Update([condition]);

        Assert.That(_events.Read().Single().Since, Is.EqualTo(began));
        Assert.That(_log, Has.Count.EqualTo(1));
    }

    [Test]
    public void Update_NormalAtStartButBeginsLater_AddsAnEventImmediately()
    {
        _time.Advance(EventList.StartGrace);

        _events.Update([Joint("a") with { IsNormalAtStart = true }]);

        Assert.That(_events.Read(), Has.Count.EqualTo(1));
    }

    [TestCase("", "", "joint a is refused", "joint a is refused (since 2026-11-20 12:00:00 UTC)")]
    [TestCase("NaN", "", "joint a is refused: NaN", "joint a is refused: NaN (since 2026-11-20 12:00:00 UTC)")]
    [TestCase("", "Repair it.", "joint a is refused. Repair it.", "joint a is refused (since 2026-11-20 12:00:00 UTC). Repair it.")]
    [TestCase("NaN.", "Repair it.", "joint a is refused: NaN. Repair it.", "joint a is refused: NaN (since 2026-11-20 12:00:00 UTC). Repair it.")]
    public void Text_WithOrWithoutReasonAndRemedy_HasTheExpectedSentences(string reason, string remedy, string text, string withSince)
    {
        var condition = Joint("a", reason, new DateTimeOffset(2026, 11, 20, 12, 0, 0, TimeSpan.Zero)) with { Remedy = remedy };

        Assert.That((condition.Text, condition.TextWithSince), Is.EqualTo((text, withSince)));
    }

    [Test]
    public void Note_AnyCondition_AddsAnEventThatEndsImmediately()
    {
        _events.Note(new Condition("recording", "x.jsonl", "was deleted", "", Level.Warning));
        _events.Update([]);

        Assert.That(_events.Read().Single().Until, Is.EqualTo(_time.GetUtcNow()));
        Assert.That(_log, Has.Count.EqualTo(1));
    }

    [Test]
    public void Update_TooManyEvents_KeepsTheNewestAndTheActiveEvents()
    {
        var lasting = Joint("lasting");
        for (var i = 0; i < 1000; i++)
        {
            _events.Update([lasting, Joint($"{i}")]);
            _events.Update([lasting]);
        }

        var kept = _events.Read();
        Assert.That(kept, Has.Count.EqualTo(EventList.MaxEvents));
        Assert.That(kept[0].Condition.Which, Is.EqualTo("999"));
        Assert.That(kept[^1].Condition.Which, Is.EqualTo("lasting"));
        Assert.That(_events.Read(10), Has.Count.EqualTo(11), "active events are never omitted");
    }

    // In the largest cell, the end of one source is a condition of each of its 256 frames and 256 signals.
    [Test]
    public void Update_MoreConditionsThanTheMaximumOfEvents_BeginsEachEventOnce()
    {
        const int Count = EventList.MaxEvents + 20;
        var present = Enumerable.Range(0, Count).Select(i => Joint(i.ToString(CultureInfo.InvariantCulture))).ToArray();

        for (var i = 0; i < 3; i++) _events.Update(present);

        Assert.That(_events.Read().Select(one => one.Id), Is.EqualTo(Enumerable.Range(1, Count).Reverse()));
        _events.Update([]);
        _events.Update([Joint("later")]);
        Assert.That(_events.Read(), Has.Count.EqualTo(EventList.MaxEvents));
    }

    [Test]
    public void Csv_FieldsWithCommasQuotesAndFormulas_AreEscaped()
    {
        var text = EventText.Csv([new EventView(7, "joint", "=HYPERLINK(\"x\")", "is refused", "a, \"b\"\nc", "error", "2026-11-20T12:00:00.000Z", null, "Stop \"it\".")]);

        var lines = text.Split("\r\n");
        Assert.That(lines[0], Is.EqualTo("id,kind,which,what,reason,level,since_utc,until_utc,text"));
        Assert.That(lines[1], Is.EqualTo(
            "7,\"joint\",\"'=HYPERLINK(\"\"x\"\")\",\"is refused\",\"a, \"\"b\"\"\nc\",\"error\",\"2026-11-20T12:00:00.000Z\",\"\",\"Stop \"\"it\"\".\""));
    }
}
