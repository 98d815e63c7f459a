using System;
using System.Linq;
using Newtonsoft.Json.Linq;
using Nowpose.Editor;
using Nowpose.Editor.Messages;
using Nowpose.Editor.Setup;
using NUnit.Framework;

namespace Nowpose.Tests.Unity.Setup
{
    public class ManifestMergeTests
    {
        const string File = "Packages/manifest.json";
        const string Url = "https://pkgs.dev.azure.com/aipmr/MixedReality-Unity-Packages/_packaging/Unity-packages/npm/registry/";

        static readonly PackageOrigin Plain = PackageOrigin.OfUnity("com.unity.b", "2.0.0", min: "1.5.0", below: "3.0.0");
        static readonly PackageOrigin OpenXr = ProjectNeeds.MixedRealityOpenXr;

        static ManifestMerge Merge(string text, PackageOrigin package, ConflictRule rule = ConflictRule.Refuse)
        {
            var merge = new ManifestMerge(text, File, rule);
            merge.Need(package);
            return merge;
        }

        [Test]
        public void Need_NewPackageFromARegistry_AddsBothAndKeepsOtherEntries()
        {
            const string before = "{\n  \"dependencies\": {\n    \"com.unity.ugui\": \"1.0.0\"\n  },\n  \"testables\": [\n    \"a\"\n  ]\n}\n";

            var after = Merge(before, OpenXr).Text;

            Assert.That(after, Is.EqualTo(
                "{\n  \"dependencies\": {\n    \"com.unity.ugui\": \"1.0.0\",\n    \"com.microsoft.mixedreality.openxr\": \"1.11.2\"\n  },\n"
                + "  \"testables\": [\n    \"a\"\n  ],\n  \"scopedRegistries\": [\n    {\n      \"name\": \"Microsoft Mixed Reality\",\n"
                + "      \"url\": \"" + Url + "\",\n"
                + "      \"scopes\": [\n        \"com.microsoft.mixedreality\",\n        \"com.microsoft.mrtk\"\n      ]\n    }\n  ]\n}\n"));
        }

        [TestCase("{}", "{ \"dependencies\": { \"com.unity.b\": \"2.0.0\" } }")]
        [TestCase("{\"dependencies\":{\"a\":\"1.0.0\"}}", "{\"dependencies\":{\"a\":\"1.0.0\",\"com.unity.b\":\"2.0.0\"}}")]
        [TestCase("{ \"dependencies\": {} }", "{ \"dependencies\": { \"com.unity.b\": \"2.0.0\" } }")]
        [TestCase(
            "{\n\t\"dependencies\": {\n\t\t\"a\": \"1.0.0\"\n\t}\n}",
            "{\n\t\"dependencies\": {\n\t\t\"a\": \"1.0.0\",\n\t\t\"com.unity.b\": \"2.0.0\"\n\t}\n}")]
        [TestCase("{\r\n \"dependencies\": {\r\n }\r\n}\r\n", "{\r\n \"dependencies\": {\r\n  \"com.unity.b\": \"2.0.0\"\r\n }\r\n}\r\n")]
        [TestCase(
            "{\n  \"dependencies\": {\n    \"z\": \"1.0.0\",\n\n    \"a\": \"1.0.0\"  }\n}",
            "{\n  \"dependencies\": {\n    \"z\": \"1.0.0\",\n\n    \"a\": \"1.0.0\",\n    \"com.unity.b\": \"2.0.0\"  }\n}")]
        [TestCase(
            "{\n  \"x\": [1, 2.5e3, true, null, {\"y\": []}]\n}",
            "{\n  \"x\": [1, 2.5e3, true, null, {\"y\": []}],\n  \"dependencies\": {\n    \"com.unity.b\": \"2.0.0\"\n  }\n}")]
        public void Need_NewPackage_KeepsIndentLineEndsAndOrder(string before, string after)
        {
            Assert.That(Merge(before, Plain).Text, Is.EqualTo(after));
        }

        [TestCase("1.5.0")]
        [TestCase("2.9.9-pre.1")]
        [TestCase("https://example.org/b.git#v2.1.0")]
        [TestCase("https://example.org/all.git?path=/com.unity.b#b-v1.6.0")]
        [TestCase("file:Tarballs/com.unity.b-2.0.1.tgz")]
        public void Need_SufficientVersion_IsKept(string version)
        {
            var before = "{\"dependencies\":{\"com.unity.b\":\"" + version + "\"}}";

            var merge = Merge(before, Plain);

            Assert.That(merge.Text, Is.EqualTo(before));
            Assert.That(merge.Changes.Concat(merge.Conflicts).Concat(merge.Notes), Is.Empty);
        }

        [TestCase("1.4.9")]
        [TestCase("3.0.0")]
        [TestCase("3.0.0-pre.1")]
        [TestCase("https://example.org/b.git#1.0.0")]
        [TestCase("file:com.unity.b-1.0.0.tgz")]
        public void Need_VersionOutOfBounds_IsNamedWithItsLine(string version)
        {
            var before = "{\n\"dependencies\": {\n\"com.unity.b\": \"" + version + "\"}}";

            var refused = Merge(before, Plain);
            var replaced = Merge(before, Plain, ConflictRule.Replace);

            Assert.That(refused.Text, Is.EqualTo(before));
            Assert.That(refused.Conflicts.Single(), Is.EqualTo(
                ManifestMessages.OtherVersion(File + ":3", "com.unity.b", version, "1.5.0" + CheckResults.OrNewer(new Version(3, 0, 0)))));
            Assert.That(replaced.Text, Is.EqualTo(before.Replace(version, "2.0.0")));
            Assert.That(replaced.Conflicts, Is.Empty);
            Assert.That(replaced.Changes, Has.Count.EqualTo(1));
        }

        [TestCase("file:../b")]
        [TestCase("https://example.org/b.git#0123456789abcdef")]
        public void Need_UnreadableVersion_IsKeptWithANote(string version)
        {
            var before = "{\"dependencies\":{\"com.unity.b\":\"" + version + "\"}}";

            var merge = Merge(before, Plain);

            Assert.That(merge.Text, Is.EqualTo(before));
            Assert.That(merge.Notes.Single(), Is.EqualTo(
                ManifestMessages.VersionUnreadable("com.unity.b", version, "1.5.0" + CheckResults.OrNewer(new Version(3, 0, 0)))));
        }

        [Test]
        public void Need_ExactVersion_ReportsANewerVersion()
        {
            var merge = new ManifestMerge("{\"dependencies\":{\"com.unity.b\":\"2.0.1\"}}", File, ConflictRule.Refuse);

            merge.Need(Plain, isExact: true);

            Assert.That(merge.Conflicts.Single(), Is.EqualTo(ManifestMessages.OtherVersion(File + ":1", "com.unity.b", "2.0.1", "2.0.0")));
        }

        [Test]
        public void Need_CalledTwice_ChangesNothingTheSecondTime()
        {
            var once = Merge("{}", OpenXr).Text;

            var twice = Merge(once, OpenXr);

            Assert.That(twice.Text, Is.EqualTo(once));
            Assert.That(twice.Changes, Is.Empty);
        }

        [Test]
        public void Need_RegistryUnderAnotherName_GetsTheScopes()
        {
            var before = "{\"scopedRegistries\":[{\"name\":\"x\",\"url\":\"" + Url.TrimEnd('/') + "\",\"scopes\":[\"b\"]}]}";

            var registries = (JArray)JObject.Parse(Merge(before, OpenXr).Text)["scopedRegistries"];

            Assert.That(registries.Count, Is.EqualTo(1));
            Assert.That(
                registries[0]["scopes"].Select(scope => (string)scope),
                Is.EqualTo(new[] { "b", "com.microsoft.mixedreality", "com.microsoft.mrtk" }));
        }

        [Test]
        public void Need_ScopeOfAnotherRegistry_IsReportedOrReplaced()
        {
            const string before =
                "{\n\"scopedRegistries\":[\n{\"name\":\"x\",\"url\":\"https://old.example\",\"scopes\":[\"com.microsoft.mixedreality\"]}]}";

            var refused = Merge(before, OpenXr);
            var kept = Merge(before, OpenXr, ConflictRule.Keep);
            var replaced = Merge(before, OpenXr, ConflictRule.Replace);

            Assert.That(
                refused.Conflicts.Single(),
                Is.EqualTo(
                    ManifestMessages.OtherRegistry(File + ":3", "com.microsoft.mixedreality.openxr", "https://old.example", Url, isShared: false)));
            Assert.That(refused.CanReplaceAll);
            Assert.That(kept.Text, Does.Contain("https://old.example").And.Contain("\"com.microsoft.mixedreality.openxr\":\"1.11.2\""));
            Assert.That(((JArray)JObject.Parse(kept.Text)["scopedRegistries"]).Count, Is.EqualTo(1));
            Assert.That(replaced.Text, Does.Contain(Url).And.Not.Contain("old.example"));
        }

        [Test]
        public void Need_RegistryWithOtherScopes_IsNeverReplaced()
        {
            const string before =
                "{\"scopedRegistries\":[{\"name\":\"x\",\"url\":\"https://own.example\",\"scopes\":[\"com.microsoft.mixedreality\",\"org.own\"]}]}";

            var merge = Merge(before, OpenXr, ConflictRule.Replace);

            Assert.That(merge.Text, Is.EqualTo(before));
            Assert.That(merge.Conflicts.Single(), Does.EndWith(
                ManifestMessages.OtherRegistry("", "com.microsoft.mixedreality.openxr", "https://own.example", Url, isShared: true)));
            Assert.That(merge.CanReplaceAll, Is.False);
        }

        [TestCase("{\"testables\":[\"a\"]}", "{\"testables\":[\"a\",\"b\"]}")]
        [TestCase("{\"testables\": [ \"a\", \"c\" ]}", "{\"testables\": [ \"a\", \"c\", \"b\" ]}")]
        [TestCase("{\"testables\": [\"b\"]}", "{\"testables\": [\"b\"]}")]
        [TestCase("{\n  \"testables\": []\n}", "{\n  \"testables\": [\n    \"b\"\n  ]\n}")]
        public void NeedTestable_AnyManifest_NamesThePackageOnce(string before, string after)
        {
            var merge = new ManifestMerge(before, File, ConflictRule.Refuse);

            merge.NeedTestable("b");

            Assert.That(merge.Text, Is.EqualTo(after));
        }

        static readonly string[][] InvalidManifests =
        {
            new[] { "", ManifestMessages.NotJson(File, "1", ManifestMessages.Expected('{'), isComment: false) },
            new[] { "nothing", ManifestMessages.NotJson(File, "1", ManifestMessages.Expected('{'), isComment: false) },
            new[] { "[]", ManifestMessages.NotJson(File, "1", ManifestMessages.Expected('{'), isComment: false) },
            new[] { "{\n\"dependencies\": {\n", ManifestMessages.NotJson(File, "3", ManifestMessages.NoName, isComment: false) },
            new[] { "{\n // why\n}", ManifestMessages.NotJson(File, "2", ManifestMessages.NoName, isComment: true) },
            new[] { "{\"a\": 1,}", ManifestMessages.NotJson(File, "1", ManifestMessages.NoName, isComment: false) },
            new[] { "{\"a\": [1,]}", ManifestMessages.NotJson(File, "1", ManifestMessages.NoValue, isComment: false) },
            new[] { "{\"a\": 01}", ManifestMessages.NotJson(File, "1", ManifestMessages.Expected(','), isComment: false) },
            new[] { "{\"a\": NaN}", ManifestMessages.NotJson(File, "1", ManifestMessages.NoValue, isComment: false) },
            new[] { "{'a': 1}", ManifestMessages.NotJson(File, "1", ManifestMessages.NoName, isComment: false) },
            new[] { "{\"a\" 1}", ManifestMessages.NotJson(File, "1", ManifestMessages.Expected(':'), isComment: false) },
            new[] { "{\"a\": \"b\n\"}", ManifestMessages.NotJson(File, "1", ManifestMessages.StringEnd, isComment: false) },
            new[] { "{} {}", ManifestMessages.NotJson(File, "1", ManifestMessages.AfterObject, isComment: false) },
            new[] { "{\"a\": 1, \"a\": 2}", ManifestMessages.NotJson(File, "1", ManifestMessages.Twice("a"), isComment: false) },
            new[] { "{\"dependencies\": []}", ManifestMessages.NotAContainer(File + ":1", "dependencies", isObject: true) },
            new[] { "{\"dependencies\": {\n\"com.unity.b\": 2}}", ManifestMessages.NotAString(File + ":2", "com.unity.b") },
        };

        [TestCaseSource(nameof(InvalidManifests))]
        public void Need_InvalidManifest_ThrowsWithLineAndReason(string manifest, string message)
        {
            var error = Assert.Throws<InputException>(() => Merge(manifest, Plain));

            Assert.That(error.Message, Is.EqualTo(message));
        }

        static readonly string[][] InvalidRegistries =
        {
            new[] { "{\"scopedRegistries\": {}}", ManifestMessages.NotAContainer(File + ":1", "scopedRegistries", isObject: false) },
            new[] { "{\"scopedRegistries\": [{\"scopes\": 1}]}", ManifestMessages.Scopes(File + ":1") },
        };

        [TestCaseSource(nameof(InvalidRegistries))]
        public void Need_RegistriesOfTheWrongType_ThrowsWithTheLineNumber(string manifest, string message)
        {
            var error = Assert.Throws<InputException>(() => Merge(manifest, OpenXr));

            Assert.That(error.Message, Is.EqualTo(message));
        }

        [Test]
        public void Need_NestedTooDeep_IsRefused()
        {
            var deep = "{\"a\":" + new string('[', 100000) + new string(']', 100000) + "}";

            Assert.That(() => Merge(deep, Plain), Throws.TypeOf<InputException>().With.Message.Contains(ManifestMessages.TooDeep("64")));
        }
    }
}
