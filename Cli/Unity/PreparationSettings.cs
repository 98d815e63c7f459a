using Nowpose.Editor;
using Nowpose.Editor.Setup;

namespace Nowpose.Cli.Unity;

/// <summary>Options of a preparation.</summary>
/// <param name="HasMrtk3">Whether MRTK3 and what a HoloLens 2 needs are added.</param>
/// <param name="HasNativeWebSocket">Whether NativeWebSocket is added.</param>
/// <param name="Samples">Names of samples to copy.</param>
/// <param name="Package">Where the package comes from; null for what the project names, or else the folder that the program finds.</param>
/// <param name="OnConflict">What happens to entries that do not serve.</param>
sealed record PreparationSettings(bool HasMrtk3, bool HasNativeWebSocket, IReadOnlyList<string> Samples, string Package, ConflictRule OnConflict);
