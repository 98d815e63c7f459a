using System.Reflection;
using System.Runtime.ExceptionServices;

namespace UnityEngine;

/// <summary>Creates objects of Unity's classes, even if their constructor is private, as Unity does.</summary>
static class Construction
{
    internal static Object Create(Type type)
    {
        if (type == null || type.IsAbstract || !typeof(Object).IsAssignableFrom(type))
        {
            throw new ArgumentException($"cannot create an object of the type {type?.FullName ?? "null"}", nameof(type));
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
