using Nowpose.Editor;
using Nowpose.Editor.Setup;

namespace Nowpose.Cli.Unity;

/// <summary>Options of a preparation.</summary>
/// <param name="HasMrtk3">Whether MRTK3 and the packages for a HoloLens 2 are added.</param>
/// <param name="HasNativeWebSocket">Whether NativeWebSocket is added.</param>
/// <param name="Samples">Names of samples to copy.</param>
/// <param name="Package">Address of the package; null for the one that the project names, or else the folder that the program finds.</param>
/// <param name="OnConflict">How entries that conflict are handled.</param>
sealed record PreparationSettings(bool HasMrtk3, bool HasNativeWebSocket, IReadOnlyList<string> Samples, string Package, ConflictRule OnConflict);
