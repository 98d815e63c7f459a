using System;
using System.Collections.Concurrent;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using UnityEngine;

namespace Nowpose.UnityPlayer;

/// <summary>Methods that ask with [RuntimeInitializeOnLoadMethod] to be called when a player starts.</summary>
static class LoadMethods
{
    const BindingFlags Static = BindingFlags.Static | BindingFlags.Public | BindingFlags.NonPublic | BindingFlags.DeclaredOnly;

    static readonly ConcurrentDictionary<Assembly, List<(RuntimeInitializeLoadType, MethodInfo)>> Known = new();

    internal static void Call(RuntimeInitializeLoadType when)
    {
        foreach (var (type, method) in AppDomain.CurrentDomain.GetAssemblies().SelectMany(a => Known.GetOrAdd(a, Of)))
        {
            if (type == when) Call(method);
        }
    }

    static List<(RuntimeInitializeLoadType, MethodInfo)> Of(Assembly assembly)
    {
        var engine = typeof(World).Assembly.GetName().Name;
        if (assembly.IsDynamic || assembly.GetReferencedAssemblies().All(a => a.Name != engine)) return new();

        return assembly.GetTypes()
            .Where(t => !t.ContainsGenericParameters)
            .SelectMany(t => t.GetMethods(Static))
            .Select(m => (m.GetCustomAttribute<RuntimeInitializeOnLoadMethodAttribute>(), m))
            .Where(p => p.Item1 != null)
            .Select(p => (p.Item1.loadType, p.m))
            .ToList();
    }

    static void Call(MethodInfo method)
    {
        try
        {
            method.Invoke(null, null);
        }
        catch (TargetInvocationException e)
        {
            Debug.LogException(e.InnerException);
        }
    }
}
