using System.Runtime.CompilerServices;

[assembly: InternalsVisibleTo("Nowpose.Tests")]
[assembly: InternalsVisibleTo("Nowpose.Headless.Tests")]
