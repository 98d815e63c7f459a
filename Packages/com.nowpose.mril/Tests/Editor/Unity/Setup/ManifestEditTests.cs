using Newtonsoft.Json.Linq;
using Nowpose.Editor;
using NUnit.Framework;

namespace Nowpose.Tests
{
    public class ManifestEditTests
    {
        static readonly PackageOrigin OpenXr = PackageOrigin.Of(ScopedRegistry.Microsoft, "com.microsoft.mixedreality.openxr", "1.11.2");

        [Test]
        public void Add_ToAManifest_AddsThePackageAndItsRegistryAndKeepsTheRest()
        {
            const string before = "{\n  \"dependencies\": {\n    \"com.unity.ugui\": \"1.0.0\"\n  },\n  \"testables\": [\n    \"a\"\n  ]\n}\n";

            var after = ManifestEdit.Add(before, OpenXr);

            Assert.That(after, Is.EqualTo(
                "{\n  \"dependencies\": {\n    \"com.unity.ugui\": \"1.0.0\",\n    \"com.microsoft.mixedreality.openxr\": \"1.11.2\"\n  },\n"
                + "  \"testables\": [\n    \"a\"\n  ],\n  \"scopedRegistries\": [\n    {\n      \"name\": \"Microsoft Mixed Reality\",\n"
                + "      \"url\": \"https://pkgs.dev.azure.com/aipmr/MixedReality-Unity-Packages/_packaging/Unity-packages/npm/registry/\",\n"
                + "      \"scopes\": [\n        \"com.microsoft.mixedreality\"\n      ]\n    }\n  ]\n}\n"));
        }

        [Test]
        public void Add_Twice_ChangesNothingMore()
        {
            var once = ManifestEdit.Add("{}", OpenXr);

            Assert.That(ManifestEdit.Add(once, OpenXr), Is.EqualTo(once));
        }

        [Test]
        public void Add_RegistryThereUnderAnotherName_GetsTheScope()
        {
            var before = "{\"scopedRegistries\":[{\"name\":\"x\",\"url\":\"" + ScopedRegistry.Microsoft.Url.TrimEnd('/') + "\",\"scopes\":[\"b\"]}]}";

            var registries = (JArray)JObject.Parse(ManifestEdit.Add(before, OpenXr))["scopedRegistries"];

            Assert.That(registries.Count, Is.EqualTo(1));
            Assert.That(registries[0]["scopes"].ToString(Newtonsoft.Json.Formatting.None), Is.EqualTo("[\"b\",\"com.microsoft.mixedreality\"]"));
        }

        [TestCase("", "Packages/manifest.json:0: not a JSON object")]
        [TestCase("{\n\"dependencies\": {\n", "Packages/manifest.json:3: not a JSON object")]
        [TestCase("[]", "Packages/manifest.json:1: not a JSON object")]
        [TestCase("{\"dependencies\": []}", "Packages/manifest.json: dependencies is no object")]
        [TestCase("{\"scopedRegistries\": {}}", "Packages/manifest.json: scopedRegistries is no array")]
        public void Add_ToNoManifest_SaysWhereAndWhy(string manifest, string message)
        {
            var error = Assert.Throws<InputException>(() => ManifestEdit.Add(manifest, OpenXr));

            Assert.That(error.Message, Does.StartWith(message));
        }
    }
}
