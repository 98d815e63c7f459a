using System.Reflection;
using NUnit.Framework;
using UnityEngine;

namespace Nowpose.Tests.Unity
{
    /// <summary>Sets the fields that the Inspector shows.</summary>
    static class Serialized
    {
        public static T With<T>(this T target, string field, object value) where T : Object
        {
            var info = typeof(T).GetField(field, BindingFlags.Instance | BindingFlags.NonPublic);
            Assert.That(info, Is.Not.Null, typeof(T).Name + " has no field " + field);
            info.SetValue(target, value);
            return target;
        }
    }
}
