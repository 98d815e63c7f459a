using System;

namespace UnityEngine;

public class Debug
{
    public static bool isDebugBuild => true;

    public static void Log(object message) => Log(message, null);
    public static void Log(object message, Object context) => Write(LogType.Log, message, context);
    public static void LogWarning(object message) => LogWarning(message, null);
    public static void LogWarning(object message, Object context) => Write(LogType.Warning, message, context);
    public static void LogError(object message) => LogError(message, null);
    public static void LogError(object message, Object context) => Write(LogType.Error, message, context);
    public static void LogException(Exception exception) => LogException(exception, null);

    public static void LogException(Exception exception, Object context) =>
        World.Current.Log(new LogEntry(LogType.Exception, $"{exception.GetType().Name}: {exception.Message}", exception, context));

    public static void Assert(bool condition) => Assert(condition, "Assertion failed");

    public static void Assert(bool condition, string message)
    {
        if (!condition) Write(LogType.Assert, message, null);
    }

    public static void DrawLine(Vector3 start, Vector3 end) { }
    public static void DrawLine(Vector3 start, Vector3 end, Color color) { }
    public static void DrawLine(Vector3 start, Vector3 end, Color color, float duration) { }

    static void Write(LogType type, object message, Object context) =>
        World.Current.Log(new LogEntry(type, message?.ToString() ?? "Null", null, context));
}
