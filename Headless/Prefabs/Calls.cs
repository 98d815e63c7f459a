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

    static UnityEventBase Event(Component owner, string field) => Fields.Get<UnityEventBase>(owner, field);
}
