namespace UnityEngine;

public partial class Object
{
    public static T FindObjectOfType<T>() where T : Object => FindObjectOfType<T>(false);
    public static T FindObjectOfType<T>(bool includeInactive) where T : Object => Search.First<T>(includeInactive);
    public static T[] FindObjectsOfType<T>() where T : Object => FindObjectsOfType<T>(false);
    public static T[] FindObjectsOfType<T>(bool includeInactive) where T : Object => Search.All<T>(includeInactive).ToArray();
}
