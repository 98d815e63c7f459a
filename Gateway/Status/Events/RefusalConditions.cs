using Nowpose.Gateway.Hub;

namespace Nowpose.Gateway.Status.Events;

/// <summary>Finds the sources and clients whose messages the gateway refuses. Thread-safe.</summary>
sealed class RefusalConditions
{
    readonly RecentRefusals _owned;
    readonly LastingRefusals _messages;
    readonly RefusedNames _names;
    readonly BrokenRules _rules;

    public RefusalConditions(MessageHub hub, TimeProvider time)
    {
        (_owned, _messages) = (new RecentRefusals(time), new LastingRefusals(time));
        (_names, _rules) = (new RefusedNames(time), new BrokenRules(time));
        hub.Refused += _owned.Add;
        hub.TopicReleased += _owned.Remove;
        hub.MessageRefused += _messages.Refuse;
        hub.TopicReleased += _messages.Release;
        hub.NameRefused += _names.Add;
        hub.RuleBroken += _rules.Add;
    }

    /// <summary>Ends the refusals about the joints of accepted set-points, or about the robot of an accepted description.</summary>
    /// <param name="message">A message on /joint_trajectory or /robot_description of any robot.</param>
    public void Accept(HubMessage message) =>
        _messages.Accept(message.Source, message.Topic, (message.Content as JointTrajectoryMessage)?.Names);

    public IEnumerable<Condition> Read() => _owned.Read().Select(OfOwned).Concat(_messages.Read().Select(OfMessage))
        .Concat(_names.Read().Select(OfName)).Concat(_rules.Read().Select(OfRule));

    static Condition OfOwned((string Source, string Kind, string Name, string Owner) one) =>
        OfSource(one.Source, $"{one.Kind} {one.Name}", EventTexts.Taken(one.Owner, one.Kind), EventRemedies.TwoSources);

    static Condition OfMessage((string Source, string Topic, string Joint, Refusal Refusal) one)
    {
        var (topic, refusal) = (RobotTopic.Parse(one.Topic), one.Refusal);
        // An error like an invalid description that is published: headsets show neither of the two.
        if (topic.Kind == RosTopics.RobotDescription)
            return new("description", $"{one.Topic} ({one.Source})", EventTexts.IsRefused, $"{refusal.What} {refusal.Rule}", Level.Error)
            {
                Headline = EventTexts.RefusedDescription(topic.Robot, one.Source),
            };
        var what = EventTexts.SetPointsOf(topic.Robot);
        return refusal.Owner is { } owner
            ? OfSource(one.Source, what, EventTexts.SetPointsTaken(owner.Title, one.Joint), EventRemedies.TwoSources)
            : OfSource(one.Source, what, $"{refusal.Rule} ({refusal.Reason})", EventRemedies.SetPoints(refusal.Reason)) with
            {
                // The clock of the source may not be measured yet.
                IsNormalAtStart = refusal.Reason == DropReason.Unsynchronised,
            };
    }

    static Condition OfSource(string source, string what, string reason, string remedy) =>
        new("source", EventTexts.SourceOf(source, what), EventTexts.IsRefused, reason, Level.Warning)
        {
            Headline = EventTexts.SourceRefused(source, what),
            Remedy = remedy,
        };

    static Condition OfRule((string Client, string What, string Rule) one) => new("source", one.Client, one.What, one.Rule, Level.Warning);

    static Condition OfName((string Name, string Client) one)
    {
        var isAdapter = StatusObjects.IsAdapter(one.Name);
        return new Condition(
            isAdapter ? "adapter" : "headset", isAdapter ? StatusObjects.AdapterName(one.Name) : one.Name, EventTexts.HasUsedName,
            EventTexts.NameUsed(one.Client), Level.Warning)
        {
            Remedy = isAdapter ? EventRemedies.AdapterNames : EventRemedies.HeadsetNames,
        };
    }
}
