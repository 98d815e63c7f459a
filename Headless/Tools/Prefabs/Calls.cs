using UnityEngine.Events;
using Object = UnityEngine.Object;

namespace Nowpose.Prefabs;

/// <summary>Adds persistent calls to the events of components, as the Inspector does.</summary>
static class Calls
{
    /// <summary>Adds a call without an argument.</summary>
    public static void Add(Component owner, string eventField, Object target, string method) =>
        Event(owner, eventField).Persistent.Add(PersistentCall.Of(target, method, PersistentListenerMode.Void, null));

    /// <summary>Adds a call with a number as argument.</summary>
    public static void Add(Component owner, string eventField, Object target, string method, float argument) =>
        Event(owner, eventField).Persistent.Add(PersistentCall.Of(target, method, PersistentListenerMode.Float, argument));

    /// <summary>Adds a call with a Boolean argument.</summary>
    public static void Add(Component owner, string eventField, Object target, string method, bool argument) =>
        Event(owner, eventField).Persistent.Add(PersistentCall.Of(target, method, PersistentListenerMode.Bool, argument));

    /// <summary>Adds a call that receives the argument of the event.</summary>
    public static void AddDynamic(Component owner, string eventField, Object target, string method) =>
        Event(owner, eventField).Persistent.Add(PersistentCall.Of(target, method, PersistentListenerMode.EventDefined, null));

    /// <summary>Adds a call to an event that is not a field of a component. The argument is a float, a bool, or null for none.</summary>
    public static void Add(UnityEvent happened, Object target, string method, object argument)
    {
        var mode = argument switch
        {
            null => PersistentListenerMode.Void,
            bool => PersistentListenerMode.Bool,
            _ => PersistentListenerMode.Float,
        };
        happened.Persistent.Add(PersistentCall.Of(target, method, mode, argument));
    }

    static UnityEventBase Event(Component owner, string field) => Fields.Get<UnityEventBase>(owner, field);
}
