using System.Collections.Generic;

namespace UnityEngine;

public class PlayerPrefs
{
    public static bool HasKey(string key) => All.ContainsKey(key);
    public static void DeleteKey(string key) => All.Remove(key);
    public static void DeleteAll() => All.Clear();
    public static void Save() { }

    public static float GetFloat(string key) => GetFloat(key, 0);
    public static float GetFloat(string key, float defaultValue) => Get(key, defaultValue);
    public static void SetFloat(string key, float value) => All[key] = value;
    public static int GetInt(string key) => GetInt(key, 0);
    public static int GetInt(string key, int defaultValue) => Get(key, defaultValue);
    public static void SetInt(string key, int value) => All[key] = value;
    public static string GetString(string key) => GetString(key, "");
    public static string GetString(string key, string defaultValue) => Get(key, defaultValue);
    public static void SetString(string key, string value) => All[key] = value;

    static Dictionary<string, object> All => World.Current.Preferences;

    static T Get<T>(string key, T otherwise) => All.TryGetValue(key, out var value) && value is T found ? found : otherwise;
}
