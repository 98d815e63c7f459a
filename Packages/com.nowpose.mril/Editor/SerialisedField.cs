using System;
using System.Collections.Generic;
using UnityEditor;
using Object = UnityEngine.Object;

namespace Nowpose.Editor
{
    /// <summary>Reads and writes one serialised field of an object.</summary>
    static class SerialisedField
    {
        /// <summary>Reads a field. Returns the default value if the object is null or does not have the field.</summary>
        /// <param name="owner">Object with the field; may be null.</param>
        /// <param name="name">Serialised name of the field.</param>
        /// <param name="read">Returns the value of the property. The property is valid only during the call.</param>
        public static T Read<T>(Object owner, string name, Func<SerializedProperty, T> read)
        {
            if (owner == null) return default;
            using var serialised = new SerializedObject(owner);
            var field = serialised.FindProperty(name);
            return field == null ? default : read(field);
        }

        /// <summary>Writes a field, with one step for Undo.</summary>
        /// <returns>False if the object is null or does not have the field.</returns>
        public static bool Write(Object owner, string name, Action<SerializedProperty> write) => Read(owner, name, field =>
        {
            write(field);
            field.serializedObject.ApplyModifiedProperties();
            return true;
        });

        /// <summary>Returns the object to which a field refers; null if it does not refer to an object of this type.</summary>
        public static T Referenced<T>(Object owner, string name) where T : Object => Read(owner, name, field => field.objectReferenceValue as T);

        /// <summary>Returns the objects to which the elements of a list refer.</summary>
        public static IEnumerable<Object> References(SerializedProperty list)
        {
            for (var i = 0; i < list.arraySize; i++) yield return list.GetArrayElementAtIndex(i).objectReferenceValue;
        }
    }
}
