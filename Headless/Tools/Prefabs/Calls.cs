using UnityEngine;
using UnityEngine.Events;
using Object = UnityEngine.Object;

namespace Nowpose.Prefabs;

/// <summary>Adds calls to events of components, as the Inspector does.</summary>
static class Calls
{
    /// <summary>Adds a call without an argument.</summary>
    public static void Add(Component owner, string eventField, Object target, string method) =>
        Event(owner, eventField).Persistent.Add(PersistentCall.Of(target, method, PersistentListenerMode.Void, null));

    /// <summary>Adds a call with a number.</summary>
    public static void Add(Component owner, string eventField, Object target, string method, float argument) =>
        Event(owner, eventField).Persistent.Add(PersistentCall.Of(target, method, PersistentListenerMode.Float, argument));

    /// <summary>Adds a call with a Boolean.</summary>
    public static void Add(Component owner, string eventField, Object target, string method, bool argument) =>
        Event(owner, eventField).Persistent.Add(PersistentCall.Of(target, method, PersistentListenerMode.Bool, argument));

    /// <summary>Adds a call with the event's argument.</summary>
    public static void AddDynamic(Component owner, string eventField, Object target, string method) =>
        Event(owner, eventField).Persistent.Add(PersistentCall.Of(target, method, PersistentListenerMode.EventDefined, null));

    /// <summary>Adds a call to an event that is not a component's field, with or without a number.</summary>
    public static void Add(UnityEvent happened, Object target, string method, float? argument) => happened.Persistent.Add(
        PersistentCall.Of(target, method, argument.HasValue ? PersistentListenerMode.Float : PersistentListenerMode.Void, argument));

    static UnityEventBase Event(Component owner, string field) => Fields.Get<UnityEventBase>(owner, field);
}
