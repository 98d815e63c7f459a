using System.Reflection;
using UnityEngine.Events;

namespace UnityEngine.Rendering;

/// <summary>
/// Implements Application.onBeforeRender. Calls the handlers in the order of their BeforeRenderOrder attribute, then in the order of
/// subscription.
/// </summary>
sealed class BeforeRender
{
    readonly List<(int Order, UnityAction Call)> _calls = new();
    readonly List<UnityAction> _calling = new();

    internal int Count => _calls.Count;

    internal void Add(UnityAction call)
    {
        var order = call.Method.GetCustomAttribute<BeforeRenderOrderAttribute>()?.order ?? 0;
        var index = _calls.Count;
        while (index > 0 && _calls[index - 1].Order > order) index--;
        _calls.Insert(index, (order, call));
    }

    internal void Remove(UnityAction call)
    {
        var index = _calls.FindIndex(c => c.Call == call);
        if (index >= 0) _calls.RemoveAt(index);
    }

    internal void Invoke()
    {
        // Iterates over a copy, because a handler may unsubscribe.
        _calling.Clear();
        foreach (var (_, call) in _calls) _calling.Add(call);
        foreach (var call in _calling) Callbacks.Call(call);
    }
}
