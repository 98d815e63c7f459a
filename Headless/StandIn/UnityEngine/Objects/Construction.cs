using System;
using System.Reflection;
using System.Runtime.ExceptionServices;

namespace UnityEngine;

/// <summary>Creates objects of the engine's classes with any constructor, including private ones, like the engine.</summary>
static class Construction
{
    internal static Object Create(Type type)
    {
        if (type == null || type.IsAbstract || !typeof(Object).IsAssignableFrom(type))
        {
            throw new ArgumentException($"no object can be made of {type?.FullName ?? "no type"}", nameof(type));
        }

        try
        {
            return (Object)Activator.CreateInstance(type, nonPublic: true);
        }
        catch (TargetInvocationException e)
        {
            ExceptionDispatchInfo.Capture(e.InnerException ?? e).Throw();
            throw;
        }
    }
}
