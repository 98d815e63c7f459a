using System.Reflection;
using Nowpose.Unity.Session;
using Nowpose.Unity.Tests.Manual;
using NUnit.Framework;
using UnityEngine;

namespace Nowpose.Unity.Tests.Surface;

/// <summary>Tests the events of all components.</summary>
public class EventTests
{
    const BindingFlags Own = BindingFlags.DeclaredOnly | BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic;

    static IEnumerable<EventInfo> Events => InspectedType.All.Where(typeof(MonoBehaviour).IsAssignableFrom).SelectMany(type => type.GetEvents());

    // A listener that is still called after its removal would keep its object, and would act on an object that was destroyed.
    [TestCaseSource(nameof(Events))]
    public void Event_ListenerRemoved_HasNone(EventInfo raised)
    {
        using var player = new Nowpose.UnityPlayer.Player();
        var made = new GameObject("made");
        made.SetActive(false);
        var component = made.AddComponent(raised.DeclaringType);
        var listener = Delegate.CreateDelegate(raised.EventHandlerType, null, ListenerOf(raised.EventHandlerType));

        raised.AddEventHandler(component, listener);
        var added = Listening(component);
        raised.RemoveEventHandler(component, listener);

        Assert.That((added, Listening(component)), Is.EqualTo((1, 0)));
    }

    static MethodInfo ListenerOf(Type type)
    {
        MethodInfo Method(string name) => typeof(EventTests).GetMethod(name, BindingFlags.Static | BindingFlags.NonPublic);
        return type == typeof(Action) ? Method(nameof(Ignore)) : Method(nameof(IgnoreValue)).MakeGenericMethod(type.GetGenericArguments());
    }

    static void Ignore() { }

    static void IgnoreValue<T>(T value) => _ = value;

    // Counts the listeners in all events of a component.
    static int Listening(Component component) => component.GetType().GetFields(Own).Sum(field => CountOf(field.GetValue(component)));

    static int CountOf(object value)
    {
        if (value is Delegate all) return all.GetInvocationList().Length;
        var type = value?.GetType();
        var isEvent = type is { IsGenericType: true } && type.GetGenericTypeDefinition() == typeof(Listeners<>);
        return isEvent ? ((Array)type.GetField("_each", Own).GetValue(value)).Length : 0;
    }
}
