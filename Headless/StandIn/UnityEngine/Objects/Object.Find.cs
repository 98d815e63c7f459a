using System;

namespace UnityEngine;

public partial class Object
{
    public static Object FindObjectOfType(Type type) => FindObjectOfType(type, false);
    public static Object FindObjectOfType(Type type, bool includeInactive) => Search.First(type, includeInactive);
    public static T FindObjectOfType<T>() where T : Object => (T)FindObjectOfType(typeof(T));
    public static T FindObjectOfType<T>(bool includeInactive) where T : Object => (T)FindObjectOfType(typeof(T), includeInactive);
    public static T[] FindObjectsOfType<T>() where T : Object => FindObjectsOfType<T>(false);
    public static T[] FindObjectsOfType<T>(bool includeInactive) where T : Object => Search.All<T>(typeof(T), includeInactive).ToArray();
}
