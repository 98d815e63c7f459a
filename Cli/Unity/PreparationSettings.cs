using Nowpose.Editor;
using Nowpose.Editor.Setup;

namespace Nowpose.Cli.Unity;

/// <summary>Options for the preparation of a project.</summary>
/// <param name="HasMrtk3">Whether to add MRTK3 and the packages for a HoloLens 2.</param>
/// <param name="HasNativeWebSocket">Whether to add NativeWebSocket.</param>
/// <param name="Samples">Names of the samples to copy.</param>
/// <param name="Package">Address of the package. If null: the address in the manifest, or else the folder that the program finds.</param>
/// <param name="OnConflict">Treatment of conflicting entries.</param>
sealed record PreparationSettings(bool HasMrtk3, bool HasNativeWebSocket, IReadOnlyList<string> Samples, string Package, ConflictRule OnConflict);
