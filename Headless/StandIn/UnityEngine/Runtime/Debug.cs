namespace UnityEngine;

public class Debug
{
    public static void Log(object message) => Log(message, null);
    public static void Log(object message, Object context) => Write(LogType.Log, message, context);
    public static void LogWarning(object message) => LogWarning(message, null);
    public static void LogWarning(object message, Object context) => Write(LogType.Warning, message, context);
    public static void LogError(object message) => LogError(message, null);
    public static void LogError(object message, Object context) => Write(LogType.Error, message, context);
    public static void LogException(Exception exception) => LogException(exception, null);

    public static void LogException(Exception exception, Object context) =>
        World.Current.Log(LogType.Exception, $"{exception.GetType().Name}: {exception.Message}", exception, context);

    static void Write(LogType type, object message, Object context) =>
        World.Current.Log(type, message?.ToString() ?? "Null", null, context);
}

public enum LogType
{
    Error = 0,
    Assert = 1,
    Warning = 2,
    Log = 3,
    Exception = 4,
}
