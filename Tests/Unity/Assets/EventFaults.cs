using System.Collections;
using System.Reflection;
using UnityEngine;
using UnityEngine.Events;
using UnityEngine.Serialization;
using Object = UnityEngine.Object;

namespace Nowpose.Unity.Tests.Assets;

/// <summary>Finds errors in the persistent calls of events.</summary>
static class EventFaults
{
    /// <summary>Returns all events in the fields of a component and of nested objects, each with its place.</summary>
    public static IEnumerable<(string Place, UnityEventBase Event)> EventsOf(Component component) =>
        EventsIn(component, component.name + " " + component.GetType().Name);

    /// <summary>Checks the persistent calls of an event.</summary>
    /// <returns>One line for each call that would fail.</returns>
    public static IEnumerable<string> Of(UnityEventBase happened) =>
        happened.Persistent.Calls.Select(call => FaultOf(call, happened.ArgumentTypes)).Where(fault => fault != null);

    static string FaultOf(PersistentCall call, Type[] arguments)
    {
        if (call.Target == null) return "calls " + call.MethodName + " of nothing";
        var type = call.Target.GetType();
        if (!Names(type).Contains(call.TargetTypeName)) return $"calls a {call.TargetTypeName}, but its target is a {type.FullName}";
        var method = call.Method(arguments);
        if (method == null) return $"calls {type.Name}.{call.MethodName}, which does not exist with an argument of mode {call.Mode}";
        return method.IsPublic && !method.IsStatic ? null : $"calls {type.Name}.{call.MethodName}, which is not public";
    }

    static IEnumerable<string> Names(Type type)
    {
        for (var at = type; at != null && at != typeof(object); at = at.BaseType) yield return at.FullName + ", " + at.Assembly.GetName().Name;
    }

    static IEnumerable<(string, UnityEventBase)> EventsIn(object owner, string place) => SerializedFields.Of(owner.GetType())
        .SelectMany(f => EventsAt(f.GetValue(owner), f.FieldType, place + "." + SerializedFields.NameOf(f)));

    static IEnumerable<(string, UnityEventBase)> EventsAt(object value, Type type, string place)
    {
        if (value == null || value is Object || type == typeof(string)) return [];
        if (value is UnityEventBase happened) return [(place, happened)];
        if (value is IEnumerable items) return items.Cast<object>().SelectMany((item, i) => EventsAt(item, item?.GetType(), $"{place}[{i}]"));
        return SerializedFields.IsNested(type) && !SerializedFields.IsEngineValue(type) ? EventsIn(value, place) : [];
    }
}
