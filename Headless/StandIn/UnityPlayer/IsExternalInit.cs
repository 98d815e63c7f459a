namespace System.Runtime.CompilerServices;

/// <summary>Needed by the compiler for records. .NET Standard 2.1 does not have this type.</summary>
static class IsExternalInit { }
