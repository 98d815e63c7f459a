using System.Collections.Generic;
using System.Reflection;
using UnityEngine.Events;

namespace UnityEngine.Rendering;

/// <summary>Application.onBeforeRender: called by the order that an attribute on the method gives, then as they came.</summary>
sealed class BeforeRender
{
    readonly List<(int Order, UnityAction Call)> _calls = new();

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
        for (var i = 0; i < _calls.Count; i++)
        {
            try
            {
                _calls[i].Call();
            }
            catch (System.Exception e)
            {
                Debug.LogException(e);
            }
        }
    }
}
