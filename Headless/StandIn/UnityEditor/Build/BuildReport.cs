namespace UnityEditor.Build.Reporting;

public sealed class BuildReport : Object
{
    BuildReport() { }
}
