using System.Reflection;
using NUnit.Framework;
using UnityEngine;

namespace Nowpose.Tests.Unity
{
    /// <summary>Sets and gets serialised fields by name, as the Inspector does.</summary>
    static class Serialized
    {
        public static T With<T>(this T target, string field, object value) where T : Object
        {
            FieldOf(target, field).SetValue(target, value);
            return target;
        }

        public static object Shown(this Object target, string field) => FieldOf(target, field).GetValue(target);

        static FieldInfo FieldOf(Object target, string field)
        {
            var info = target.GetType().GetField(field, BindingFlags.Instance | BindingFlags.NonPublic);
            Assert.That(info?.IsDefined(typeof(SerializeField)), Is.True, target.GetType().Name + " has no serialised field " + field);
            return info;
        }
    }
}
