using UnityEngine;
using UnityEngine.Events;
using Object = UnityEngine.Object;

namespace Nowpose.Prefabs;

/// <summary>Adds calls to events of components, as the Inspector does.</summary>
static class Calls
{
    /// <summary>Without an argument.</summary>
    public static void Add(Component owner, string eventField, Object target, string method) =>
        Event(owner, eventField).Persistent.Add(PersistentCall.Of(target, method, PersistentListenerMode.Void, null));

    /// <summary>With a number.</summary>
    public static void Add(Component owner, string eventField, Object target, string method, float argument) =>
        Event(owner, eventField).Persistent.Add(PersistentCall.Of(target, method, PersistentListenerMode.Float, argument));

    /// <summary>With yes or no.</summary>
    public static void Add(Component owner, string eventField, Object target, string method, bool argument) =>
        Event(owner, eventField).Persistent.Add(PersistentCall.Of(target, method, PersistentListenerMode.Bool, argument));

    /// <summary>With what the event passes on.</summary>
    public static void AddDynamic(Component owner, string eventField, Object target, string method) =>
        Event(owner, eventField).Persistent.Add(PersistentCall.Of(target, method, PersistentListenerMode.EventDefined, null));

    /// <summary>To an event that is no component's field, with a number or without.</summary>
    public static void Add(UnityEvent happened, Object target, string method, float? argument) => happened.Persistent.Add(
        PersistentCall.Of(target, method, argument.HasValue ? PersistentListenerMode.Float : PersistentListenerMode.Void, argument));

    static UnityEventBase Event(Component owner, string field) => Fields.Get<UnityEventBase>(owner, field);
}
